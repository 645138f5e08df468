/**
 * Cameras on a network. What a service sees in their frames belongs to the service; the phone's
 * camera to {@code u2sa-android}.
 */
package org.u2sa.drivers.camera;
