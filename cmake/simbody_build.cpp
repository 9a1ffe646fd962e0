// Prints how Simbody was built: debug (without NDEBUG) or release. Exit code 1 if it does not say.

#include <cstdio>
#include <cstring>

extern "C" void SimTK_about_SimTKcommon(const char* key, int size, char* value);

int main() {
  char build[32] = "";
  SimTK_about_SimTKcommon("debug", sizeof build, build);
  std::printf("%s", build);
  return std::strcmp(build, "debug") == 0 || std::strcmp(build, "release") == 0 ? 0 : 1;
}
