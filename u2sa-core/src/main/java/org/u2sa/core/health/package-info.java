/**
 * Watches how the services of a system are and has the failed ones started again. What is done with
 * the vehicle when something is wrong does not belong here, nor how services are started.
 */
package org.u2sa.core.health;
