/**
 * Missions as other ground stations have them, item by item as MAVLink defines them, and in the
 * file formats: QGroundControl's plans and lists of waypoints (QGC WPL 110). What items or goals
 * cannot say is named.
 */
package org.u2sa.gcs.plan;
