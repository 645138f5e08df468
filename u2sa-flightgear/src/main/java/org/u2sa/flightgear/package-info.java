/**
 * Messages specific to aeroplanes. Links to simulators are in {@code link} and {@code protocol}.
 */
package org.u2sa.flightgear;
