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
  private final DatagramChannel channel;
  private final StationSession session;
  private final StationReader reader = new StationReader();

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
      reader.read(bytes -> channel.read(ByteBuffer.wrap(bytes)), session, nowMicros);
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
