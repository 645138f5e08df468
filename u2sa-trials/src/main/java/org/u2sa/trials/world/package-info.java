/** The command line's {@code u2sa world}. */
package org.u2sa.trials.world;
