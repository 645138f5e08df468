package org.u2sa.device.port;

/** A camera: {@link CameraFrame}. Closing it switches it off. */
public interface Camera extends Device<CameraFrame> {}
