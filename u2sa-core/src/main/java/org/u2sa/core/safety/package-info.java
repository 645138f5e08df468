/**
 * Failsafe actions and permission to move: failsafe matrix, geofence and pre-arm checks. Monitoring
 * of services belongs to health, reaching goals to planning.
 */
package org.u2sa.core.safety;
