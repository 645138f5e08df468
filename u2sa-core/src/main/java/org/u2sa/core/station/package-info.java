/**
 * The operator's page, which the embedded broker serves to browsers. Its scripts are in the
 * resources; they have no libraries and need no network.
 */
package org.u2sa.core.station;
