package org.u2sa.gcs.mavlink;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.DatagramChannel;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.util.List;

/** One station by UDP; datagrams from other addresses are ignored. */
final class UdpLink implements StationLink {
  private static final int LARGEST = 4096;
  private static final int PER_TURN = 64;

  private final DatagramChannel channel;
  private final StationSession session;
  private final ByteBuffer buffer = ByteBuffer.allocate(LARGEST);

  UdpLink(InetSocketAddress station, StationSession session, Selector selector) throws IOException {
    this.session = session;
    channel = DatagramChannel.open();
    channel.configureBlocking(false);
    channel.connect(station);
    channel.register(selector, SelectionKey.OP_READ);
  }

  @Override
  public void exchange(long nowMicros) {
    try {
      for (int i = 0; i < PER_TURN; i++) {
        buffer.clear();
        int length = channel.read(buffer);
        if (length <= 0) {
          break;
        }
        if (length <= session.allowance(nowMicros)) { // else a flood: dropped, as UDP may
          session.receive(buffer.array(), length, nowMicros);
        }
      }
      send();
    } catch (IOException e) {
      return; // no station listens there yet, or its network is down; it will receive later packets
    }
  }

  private void send() throws IOException {
    for (byte[] packet = session.poll(); packet != null; packet = session.poll()) {
      channel.write(ByteBuffer.wrap(packet));
    }
  }

  @Override
  public Iterable<StationSession> sessions() {
    return List.of(session);
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
