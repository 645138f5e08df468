/**
 * State estimators (thesis 3.2.3.1): compute the best estimate of the vehicle's state from sensor
 * measurements, for use by all other services. Sensors do not belong here.
 */
package org.u2sa.estimation;
