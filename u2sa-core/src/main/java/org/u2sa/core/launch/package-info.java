/**
 * Starts and stops what a system file lists: the Communication Manager and the services of a
 * vehicle. How a service is written does not belong here.
 */
package org.u2sa.core.launch;
