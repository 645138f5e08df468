/**
 * Recording of runs: every message of a system, into files. Demos and command lines that use the
 * files are elsewhere.
 */
package org.u2sa.recorder;
