/**
 * The rosbridge protocol, version 2, for ROS tools: standard ROS messages made from the vehicle's,
 * the native messages, services for listing and configuration. A client has exactly the rights of
 * the broker user that it logs in as.
 */
package org.u2sa.gcs.ros;
