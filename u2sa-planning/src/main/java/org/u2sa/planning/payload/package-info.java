/** How payloads are released and fall. Flying to the release point does not belong here. */
package org.u2sa.planning.payload;
