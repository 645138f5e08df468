/**
 * Commands that show what passes through a running system, and put a message in by hand. They
 * change nothing but for {@code publish}; what is remembered of a run is {@code record}'s.
 */
package org.u2sa.cli.look;
