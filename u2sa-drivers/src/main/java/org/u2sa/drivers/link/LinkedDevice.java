package org.u2sa.drivers.link;

import java.util.Optional;
import org.u2sa.device.Device;

/**
 * A device at the other end of a link: begins anew with each connection, hears what has come, and
 * then says what is to be said. Belongs to one thread.
 */
public abstract class LinkedDevice<R extends Device.Reading> implements Device<R> {
  private static final int BUFFER_BYTES = 4_096;
  private static final int MOST_BYTES_A_READ = 1 << 20; // a flood must not hold its reader for ever

  protected final ByteLink link;
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private int connections;

  /** Over that link, which is closed with the device. */
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
    for (int all = 0; all < MOST_BYTES_A_READ && (count = link.read(buffer)) > 0; all += count) {
      hear(buffer, count, nowMicros);
    }
    act(nowMicros);
    return latest();
  }

  /** The device was found, maybe not for the first time: half a message is none any more. */
  protected abstract void found(long nowMicros);

  /** Takes bytes of the device; the first {@code length} count. */
  protected abstract void hear(byte[] bytes, int length, long nowMicros);

  /** Tells the device what is due, at the end of each read. */
  protected void act(long nowMicros) {}

  /** The newest reading, as {@link #read} returns it. */
  protected abstract Optional<R> latest();

  /** What is wrong with a device whose link is well; empty if nothing is. */
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
