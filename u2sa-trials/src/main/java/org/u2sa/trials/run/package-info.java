/**
 * Common parts of all demos: run a mission with the services of a system file, in lockstep or real
 * time, observe, display and score it, and repeat it over seeds. Vehicles and simulations belong to
 * the individual demos.
 */
package org.u2sa.trials.run;
