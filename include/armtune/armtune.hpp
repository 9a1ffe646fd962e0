#pragma once
// The whole C++ interface of armtune in one include. plan.hpp, identify.hpp and program.hpp need further
// libraries to link; each of them names its own.

#include "armtune/about.hpp"
#include "armtune/controller.hpp"
#include "armtune/error.hpp"
#include "armtune/front.hpp"
#include "armtune/gains.hpp"
#include "armtune/identify.hpp"
#include "armtune/plan.hpp"
#include "armtune/program.hpp"
#include "armtune/progress.hpp"
#include "armtune/report.hpp"
#include "armtune/robot.hpp"
#include "armtune/robustness.hpp"
#include "armtune/rollout.hpp"
#include "armtune/scenario.hpp"
#include "armtune/study.hpp"
#include "armtune/tune.hpp"
#include "armtune/verdict.hpp"
