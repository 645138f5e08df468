/**
 * Missions in the form of other ground stations: MAVLink's items, and the files of QGroundControl
 * (plans) and of QGC WPL 110 (waypoint lists). Conversions name everything that the other form
 * cannot express.
 */
package org.u2sa.gcs.plan;
