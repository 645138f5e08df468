/**
 * Recording of runs: every message of a system, into files. What a demo or a command line does with
 * the files is no concern of this module.
 */
package org.u2sa.recorder;
