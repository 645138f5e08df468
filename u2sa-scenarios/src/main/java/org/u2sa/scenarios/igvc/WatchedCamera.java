package org.u2sa.scenarios.igvc;

import java.util.Optional;
import org.u2sa.device.port.Camera;
import org.u2sa.device.port.CameraFrame;

/** Wraps a camera and makes its latest image available to others. */
final class WatchedCamera implements Camera {
  private final Camera camera;
  private volatile Optional<CameraFrame> newest = Optional.empty();

  WatchedCamera(Camera camera) {
    this.camera = camera;
  }

  /** Most recently read image. Thread-safe. */
  Optional<CameraFrame> newest() {
    return newest;
  }

  @Override
  public Optional<CameraFrame> read(long nowMicros) {
    newest = camera.read(nowMicros);
    return newest;
  }

  @Override
  public long malformed() {
    return camera.malformed();
  }

  @Override
  public String lastRefusal() {
    return camera.lastRefusal();
  }

  @Override
  public boolean isConnected() {
    return camera.isConnected();
  }

  @Override
  public int connections() {
    return camera.connections();
  }

  @Override
  public String trouble() {
    return camera.trouble();
  }

  @Override
  public void close() {
    camera.close();
  }
}
