package org.u2sa.drivers.link;

import java.util.Optional;
import org.u2sa.device.port.Device;

/**
 * A device on a link: resets on each connection, reads pending bytes, then writes what is due. Not
 * thread-safe.
 */
public abstract class LinkedDevice<R extends Device.Reading> implements Device<R> {
  protected final ByteLink link;

  /** Latest reading, as returned by {@link #read}; empty before the first. */
  protected Optional<R> latest = Optional.empty();

  private final PendingBytes pending = new PendingBytes();
  private int connections;
  private long refused;
  private String lastRefusal = "";

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
    pending.read(link, (bytes, length) -> hear(bytes, length, nowMicros));
    act(nowMicros);
    return latest;
  }

  /** Called on every (re)connection; discards any partial message. */
  protected abstract void found(long nowMicros);

  /** Consumes the first {@code length} bytes. */
  protected abstract void hear(byte[] bytes, int length, long nowMicros);

  /** Sends pending requests; called at the end of each read. */
  protected void act(long nowMicros) {}

  /** Counts a rejected message or a missing reply. */
  protected final void refuse(String why) {
    refused++;
    lastRefusal = why;
  }

  @Override
  public long malformed() {
    return refused;
  }

  @Override
  public String lastRefusal() {
    return lastRefusal;
  }

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
