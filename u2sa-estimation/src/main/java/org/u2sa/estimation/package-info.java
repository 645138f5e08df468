/**
 * State estimators (thesis 3.2.3.1): from what sensors measured to the best estimate that everybody
 * else uses. Sensors do not belong here.
 */
package org.u2sa.estimation;
