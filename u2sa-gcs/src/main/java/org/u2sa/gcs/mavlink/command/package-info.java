/** Commands of ground stations: each is answered, unknown ones as unsupported. */
package org.u2sa.gcs.mavlink.command;
