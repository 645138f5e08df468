/**
 * Starts and stops the Communication Manager and the services of a system file. Base classes of
 * services are elsewhere.
 */
package org.u2sa.core.launch;
