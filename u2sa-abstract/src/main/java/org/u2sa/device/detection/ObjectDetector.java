package org.u2sa.device.detection;

import java.util.List;
import org.u2sa.device.port.Device;

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
   */
  record Detection(
      String label,
      double bearingRad,
      double elevationRad,
      double rangeM,
      double angleSigmaRad,
      double rangeSigmaM,
      double radiusM) {}

  /** All objects in one picture. */
  record Detections(long measuredAtMicros, List<Detection> detections) implements Reading {}
}
