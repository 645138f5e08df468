package org.u2sa.device.detection;

import java.util.List;
import java.util.Optional;
import org.u2sa.device.port.Device;
import org.u2sa.messages.frame.Point;

/** A sensor that recognises objects itself, such as a camera with a neural network. */
public interface ObjectDetector extends Device<ObjectDetector.Detections> {
  /**
   * A recognised object.
   *
   * @param label kind of object, such as "orange buoy"
   * @param bearingRad from the sensor's forward axis, positive to the left [rad]
   * @param elevationRad above the sensor's forward axis [rad]
   * @param rangeM distance to its centre [m], not negative
   * @param angleSigmaRad standard deviation of bearing and elevation [rad]
   * @param rangeSigmaM standard deviation of the range [m]
   * @param radiusM half its width [m]; 0 if unknown
   * @param axis unit vector along its length, or along the normal of an upright hoop, in the
   *     sensor's axes forward, left, down; the opposite means the same; empty if unknown
   */
  record Detection(
      String label,
      double bearingRad,
      double elevationRad,
      double rangeM,
      double angleSigmaRad,
      double rangeSigmaM,
      double radiusM,
      Optional<Point> axis) {
    /** Creates a detection of an object whose axis is unknown. */
    public Detection(
        String label,
        double bearingRad,
        double elevationRad,
        double rangeM,
        double angleSigmaRad,
        double rangeSigmaM,
        double radiusM) {
      this(
          label,
          bearingRad,
          elevationRad,
          rangeM,
          angleSigmaRad,
          rangeSigmaM,
          radiusM,
          Optional.empty());
    }
  }

  /** All objects in one picture. */
  record Detections(long measuredAtMicros, List<Detection> detections) implements Reading {}
}
