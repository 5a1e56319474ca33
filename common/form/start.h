/*
 * How each tool that works on a case file begins: options, levels of messages, the case operand.
 */
#ifndef SEILWERK_FORM_START_H
#define SEILWERK_FORM_START_H

#include "form/cable.h"

/* Parse the options of tool and set the levels of its messages.  Returns the index of the first
 * operand in argv. */
int start_options(const struct opt_tool *tool, const struct opt_common *common, int argc,
                  char **argv);

/* Warn of numbers that are admissible, but seldom meant, by the case and its static line: most come
 * from a wrong unit.  place stands in front of each warning. */
void start_doubt(const struct cable_case *c, const struct line *line, const char *place);

/* Read the one case operand, argv[operand], with its --set assignments.  With --print-case the
 * resolved case is written and the process ends.  Ends with a message on error. */
void start_load(const struct opt_tool *tool, struct opt_common *common, int operand, int argc,
                char **argv, struct cable_case *ret);

/* Both. */
void start_case(const struct opt_tool *tool, struct opt_common *common, int argc, char **argv,
                struct cable_case *ret);

#endif
