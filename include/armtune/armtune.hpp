#pragma once
// Includes the whole C++ interface of armtune. A program that uses plan.hpp, identify.hpp or program.hpp must
// link a further library, which the comment at the head of that header names.

#include "armtune/about.hpp"
#include "armtune/controller.hpp"
#include "armtune/error.hpp"
#include "armtune/evaluate.hpp"
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
#include "armtune/run_record.hpp"
#include "armtune/scenario.hpp"
#include "armtune/study.hpp"
#include "armtune/tune.hpp"
#include "armtune/verdict.hpp"
