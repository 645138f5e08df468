/**
 * The rosbridge protocol, version 2, for ROS tools: standard ROS messages made of the vehicle's,
 * the native messages, services for listing and configuration. A client has the rights of the
 * broker's user as which it logs in; there are no rights of its own.
 */
package org.u2sa.gcs.ros;
