/**
 * What every demo does: runs of a mission by the services of a system file, in lockstep or in real
 * time, watched, shown, scored, and repeated over seeds. Vehicles and their simulations belong to
 * the demos themselves.
 */
package org.u2sa.scenarios.run;
