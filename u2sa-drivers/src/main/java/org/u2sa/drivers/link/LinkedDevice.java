package org.u2sa.drivers.link;

import java.util.Optional;
import org.u2sa.device.port.Device;

/**
 * A device on a link: resets on each connection, reads pending bytes, then writes what is due. Not
 * thread-safe.
 */
public abstract class LinkedDevice<R extends Device.Reading> implements Device<R> {
  private static final int BUFFER_BYTES = 4_096;
  private static final int MAX_BYTES_A_READ =
      1 << 20; // bounds one read so that a flood cannot starve the caller

  protected final ByteLink link;
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private int connections;

  /** Uses the link; closing the device closes it. */
  protected LinkedDevice(ByteLink link) {
    this.link = link;
  }

  @Override
  public Optional<R> read(long nowMicros) {
    if (link.connections() != connections) {
      connections = link.connections();
      found(nowMicros);
    }
    int count;
    for (int all = 0; all < MAX_BYTES_A_READ && (count = link.read(buffer)) > 0; all += count) {
      hear(buffer, count, nowMicros);
    }
    act(nowMicros);
    return latest();
  }

  /** Called on every (re)connection; discards any partial message. */
  protected abstract void found(long nowMicros);

  /** Consumes the first {@code length} bytes. */
  protected abstract void hear(byte[] bytes, int length, long nowMicros);

  /** Sends pending requests; called at the end of each read. */
  protected void act(long nowMicros) {}

  /** Latest reading, as returned by {@link #read}. */
  protected abstract Optional<R> latest();

  /** Device fault while the link is up; empty if none. */
  protected String ownTrouble() {
    return "";
  }

  @Override
  public final boolean isConnected() {
    return link.isConnected();
  }

  @Override
  public final int connections() {
    return link.connections();
  }

  @Override
  public final String trouble() {
    String trouble = link.trouble();
    return trouble.isEmpty() ? ownTrouble() : trouble;
  }

  @Override
  public void close() {
    link.close();
  }
}
