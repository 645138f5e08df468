package org.u2sa.vision.picture;

import org.u2sa.device.CameraFrame;
import org.u2sa.interfaces.BadInputException;

/**
 * Unpacks JPEG pictures, as network cameras send them. The desktop and Android each have their own;
 * found by {@link java.util.ServiceLoader}.
 */
public interface JpegDecoder {
  /**
   * The same picture as RGB24, with its time and geometry.
   *
   * @param jpeg a frame of the format JPEG
   * @throws BadInputException if it is no whole JPEG file
   */
  CameraFrame decode(CameraFrame jpeg);
}
