package org.u2sa.drivers.camera;

import static java.nio.charset.StandardCharsets.US_ASCII;

import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;
import org.u2sa.drivers.link.ByteLink;
import org.u2sa.drivers.link.LinkProvider;
import org.u2sa.drivers.link.ParsedDevice;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;

/**
 * A camera that streams JPEG images over HTTP ({@code multipart/x-mixed-replace}), like most
 * network cameras, ESP32-CAM boards and mjpg-streamer. Requests use HTTP 1.0 to avoid chunked
 * encoding (RFC 9112, 7.1). A frame's timestamp is the arrival of its first byte.
 */
public final class MjpegCamera extends ParsedDevice<CameraFrame> implements Camera {
  private final byte[] request;
  private boolean isAsked;

  /**
   * Uses the link; closing the device closes it.
   *
   * @param path path of the stream on the camera, such as {@code /?action=stream}
   */
  public MjpegCamera(ByteLink link, String path) {
    super(link, new JpegFramer());
    if (!path.matches("/[!-~]*")) {
      throw new BadInputException(
          "STREAM PATH: \"" + path + "\" is not a slash and printable characters without blanks");
    }
    request =
        ("GET " + path + " HTTP/1.0\r\nAccept: multipart/*, image/jpeg\r\n\r\n").getBytes(US_ASCII);
  }

  @Override
  protected void found(long nowMicros) {
    super.found(nowMicros);
    isAsked = false;
  }

  @Override
  protected void act(long nowMicros) {
    if (!isAsked && link.isConnected()) {
      isAsked = link.write(request);
    }
  }

  /** Provider of CAMERA = MJPEG. */
  public static final class Provider extends LinkProvider<Camera> {
    private record Variables(
        @Variable(ifAbsentText = "/?action=stream")
            @Description(
                "MJPEG: path of the stream on the camera; defaults to that of mjpg-streamer.")
            String streamPath) {}

    public Provider() {
      super(
          Camera.class,
          Variables.class,
          (name, link, own) -> new MjpegCamera(link, own.streamPath()),
          "MJPEG");
    }
  }
}
