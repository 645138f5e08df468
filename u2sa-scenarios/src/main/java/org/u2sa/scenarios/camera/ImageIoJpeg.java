package org.u2sa.scenarios.camera;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.vision.picture.JpegDecoder;

/** Decodes JPEG images with the JDK's reader. */
public final class ImageIoJpeg implements JpegDecoder {
  @Override
  public CameraFrame decode(CameraFrame jpeg) {
    try (ImageInputStream in =
        new MemoryCacheImageInputStream(new ByteArrayInputStream(jpeg.pixels()))) {
      return CameraPicture.frame(in, jpeg.measuredAtMicros(), jpeg.intrinsics());
    } catch (IOException e) {
      throw new BadInputException("a JPEG picture cannot be unpacked: " + e.getMessage(), e);
    }
  }
}
