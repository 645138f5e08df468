package org.u2sa.device.port;

/** An inertial measurement unit with attitude estimation: {@link Orientation}. */
public interface Imu extends Device<Orientation> {}
