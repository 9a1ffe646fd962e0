#pragma once
// Sine, cosine and exponential of several numbers at once, without branches. The operations are the same for
// every width and on every x86-64 processor, so the results are bit-identical. They are within 2 units in the
// last place of the exact value (3 for angles between 1000 and kLargestAngle). A NaN remains a NaN.
//
// The argument is reduced after Cody and Waite (Software Manual for the Elementary Functions, 1980), with
// pi/2 and ln 2 split into parts of 33 bits, so that multiples of these parts are exact. Polynomials then
// interpolate the function at Chebyshev nodes. Their largest error is a few per cent above that of the best
// polynomials of the same degree.

namespace armtune::internal::vector_math {

/// Two doubles in one register of any x86-64 processor.
using Double2 = double __attribute__((vector_size(16)));

/// A vector of 64-bit integers, as many as V has doubles.
template <typename V>
using Bits = decltype(V{} < V{});

/// Largest angle [rad] of sine_cosine. For larger angles, the reduction of the argument loses accuracy.
inline constexpr double kLargestAngle = 1e5;
/// 1.5 * 2^52. Adding and subtracting it rounds to the nearest integer. The lowest bits of the sum are those
/// of that integer.
inline constexpr double kRounder = 6755399441055744.0;

template <typename V>
void sine_cosine(const V& x, V& sine, V& cosine) {
  const V turned = x * 0.63661977236758134308 + kRounder;
  const V k = turned - kRounder;  // quarter turns
  const V r = ((x - k * 1.5707963267341256) - k * 6.077100506303966e-11) - k * 2.0222662487959506e-21;
  const V z = r * r;
  const V s = r + r * z *
                      (-0.16666666666666666 +
                       z * (0.008333333333330948 +
                            z * (-0.00019841269836756774 +
                                 z * (2.7557316101617874e-06 +
                                      z * (-2.505113165023518e-08 + z * 1.5918115263265974e-10)))));
  const V rest =
      z * z *
      (0.041666666666666664 +
       z * (-0.0013888888888887398 +
            z * (2.480158729876456e-05 +
                 z * (-2.7557317271145144e-07 + z * (2.087614614655861e-09 - z * 1.1382623647474604e-11)))));
  const V half = 0.5 * z;
  const V most = 1.0 - half;
  const V c = most + (((1.0 - most) - half) + rest);  // adds what the subtraction rounded away
  const auto quarter = reinterpret_cast<Bits<V>>(turned);
  const auto odd = -(quarter & 1);  // all ones where sine and cosine change places
  const auto s_bits = reinterpret_cast<Bits<V>>(s);
  const auto c_bits = reinterpret_cast<Bits<V>>(c);
  const auto changed = (s_bits ^ c_bits) & odd;
  sine = reinterpret_cast<V>((s_bits ^ changed) ^ ((quarter & 2) << 62));
  cosine = reinterpret_cast<V>((c_bits ^ changed) ^ (((quarter + 1) & 2) << 62));
}

/// Returns e^x. Beyond +-708 it returns the value at +-708, so that nothing overflows.
template <typename V>
V exponential(const V& x) {
  const V lowest = V{} - 708.0;
  const V highest = V{} + 708.0;
  // A NaN is neither below nor above, and passes through.
  const V inside = x < lowest ? lowest : (x > highest ? highest : x);
  const V shifted = inside * 1.44269504088896340736 + kRounder;
  const V k = shifted - kRounder;
  const V r = (inside - k * 0.6931471804855391) - k * 7.440617110012397e-11;
  const V p =
      0.5000000000000001 +
      r * (0.16666666666666669 +
           r * (0.04166666666662416 +
                r * (0.008333333333330063 +
                     r * (0.0013888888917199863 +
                          r * (0.00019841269863042963 +
                               r * (2.4801521317484083e-05 +
                                    r * (2.7557268476553695e-06 +
                                         r * (2.7620078203806394e-07 + r * 2.5100377619606372e-08))))))));
  const V e = 1.0 + (r + r * r * p);
  // 2^k by its exponent bits.
  return e * reinterpret_cast<V>((reinterpret_cast<Bits<V>>(shifted) + 1023) << 52);
}

}  // namespace armtune::internal::vector_math
