/**
 * Monitors the services of a system and orders restarts of failed ones. Reactions of the vehicle
 * and the starting of services belong elsewhere.
 */
package org.u2sa.core.health;
