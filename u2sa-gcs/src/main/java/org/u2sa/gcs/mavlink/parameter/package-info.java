/** The configuration variables of the services as MAVLink parameters. */
package org.u2sa.gcs.mavlink.parameter;
