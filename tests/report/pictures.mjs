// What is on a screenshot: decoded by the browser itself, on a page of its own.

export class Pictures {
  static async make(browser) {
    const made = new Pictures();
    made.page = await browser.newPage();
    return made;
  }

  /** Portion of pixels that are not the most frequent colour: zero for a blank picture. */
  async drawn(png) {
    return this.page.evaluate(async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const canvas = document.createElement("canvas");
      canvas.width = image.width;
      canvas.height = image.height;
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height);
      const counts = new Map();
      for (let i = 0; i < data.length; i += 4) {
        const key = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
        counts.set(key, (counts.get(key) ?? 0) + 1);
      }
      return 1 - Math.max(...counts.values()) / (data.length / 4);
    }, `data:image/png;base64,${png.toString("base64")}`);
  }

  /** Portion of pixels that differ by more than rounding. */
  async difference(first, second) {
    return this.page.evaluate(
      async ([a, b]) => {
        const pixels = async (source) => {
          const image = new Image();
          image.src = source;
          await image.decode();
          const canvas = document.createElement("canvas");
          canvas.width = image.width;
          canvas.height = image.height;
          const context = canvas.getContext("2d");
          context.drawImage(image, 0, 0);
          return context.getImageData(0, 0, image.width, image.height).data;
        };
        const [one, two] = [await pixels(a), await pixels(b)];
        if (one.length !== two.length) return 1;
        let changed = 0;
        for (let i = 0; i < one.length; i += 4) {
          const by = Math.abs(one[i] - two[i]) + Math.abs(one[i + 1] - two[i + 1]) + Math.abs(one[i + 2] - two[i + 2]);
          if (by > 24) ++changed;
        }
        return changed / (one.length / 4);
      },
      [first, second].map((png) => `data:image/png;base64,${png.toString("base64")}`),
    );
  }
}
