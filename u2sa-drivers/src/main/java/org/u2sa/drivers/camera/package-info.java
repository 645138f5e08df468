/**
 * Network cameras. Image processing belongs to the services, the phone's camera to {@code
 * u2sa-android}.
 */
package org.u2sa.drivers.camera;
