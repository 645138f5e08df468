/**
 * Missions in the file formats of other ground stations: QGroundControl's plans and lists of
 * waypoints (QGC WPL 110), item by item as MAVLink has them. What a format cannot say is named.
 */
package org.u2sa.gcs.plan;
