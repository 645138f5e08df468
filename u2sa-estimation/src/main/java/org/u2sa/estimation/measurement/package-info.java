/**
 * Measurements as the filters use them: quantities, values and standard deviations of one source at
 * one time.
 */
package org.u2sa.estimation.measurement;
