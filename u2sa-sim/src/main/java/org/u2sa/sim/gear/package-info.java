/** What aircraft stand and roll on. */
package org.u2sa.sim.gear;
