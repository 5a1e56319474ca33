/*
 * How each tool that works on a case file begins: options, levels of messages, the case operand.
 */
#ifndef SEILWERK_FORM_START_H
#define SEILWERK_FORM_START_H

#include "form/cable.h"

/* Parse the options of tool, read the one case operand with its --set assignments.  With
 * --print-case the resolved case is written and the process ends.  Ends with a message on error. */
void start_case(const struct opt_tool *tool, struct opt_common *common, int argc, char **argv,
                struct cable_case *ret);

#endif
