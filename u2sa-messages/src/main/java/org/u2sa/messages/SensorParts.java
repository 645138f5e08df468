package org.u2sa.messages;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Names of sensors that publish several kinds of measurements, each as a source of its own: the
 * sensor's name and a suffix. Configuration that names the sensor applies to all of its parts.
 */
public final class SensorParts {
  /** Gyroscopes and accelerometers of an IMU that also publishes attitude. */
  public static final String INERTIAL = " inertial";

  /** Position of an autopilot that also publishes attitude. */
  public static final String POSITION = " position";

  /** Objects found in the scans or clouds of a scanner. */
  public static final String OBJECTS = " objects";

  private static final List<String> SUFFIXES = List.of(INERTIAL, POSITION, OBJECTS);

  private SensorParts() {}

  /** Name of the sensor that a source is part of; the source's own name if it is no part. */
  public static String sensor(String source) {
    for (String suffix : SUFFIXES) {
      if (source.endsWith(suffix)) {
        return source.substring(0, source.length() - suffix.length());
      }
    }
    return source;
  }

  /** Value for a source: that of its own name, else that of its sensor. */
  public static <T> Optional<T> value(Map<String, T> bySensor, String source) {
    T own = bySensor.get(source);
    return Optional.ofNullable(own != null ? own : bySensor.get(sensor(source)));
  }
}
