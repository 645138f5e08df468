package org.u2sa.vision.picture;

import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;

/**
 * Decodes JPEG images, as sent by network cameras. Desktop and Android have different
 * implementations, found by {@link java.util.ServiceLoader}.
 */
public interface JpegDecoder {
  /**
   * Decodes to RGB24, keeping time and geometry.
   *
   * @param jpeg a frame of the format JPEG
   * @throws BadInputException if it is not a complete JPEG file
   */
  CameraFrame decode(CameraFrame jpeg);
}
