package org.u2sa.benchmarks.mqtt;

import java.nio.ByteBuffer;
import org.zeromq.SocketType;
import org.zeromq.ZContext;
import org.zeromq.ZMQ;
import org.zeromq.ZMQException;

/**
 * ZeroMQ's publish and subscribe over TCP in Java, from one process to another without a broker.
 */
final class JeroWay implements Way {
  private final ZContext context = new ZContext();
  private final ZMQ.Socket socket;
  private final Ways.Load load;

  JeroWay(int port, Ways.Load load, Sink sink) {
    this.load = load;
    String address = "tcp://127.0.0.1:" + port;
    if (sink == null) {
      socket = context.createSocket(SocketType.XPUB);
      socket.connect(address);
      socket.recv(); // the listener's subscription: what is sent before is lost
    } else {
      socket = context.createSocket(SocketType.SUB);
      socket.subscribe(ZMQ.SUBSCRIPTION_ALL);
      socket.bind(address);
      Thread reader = new Thread(() -> read(sink), "jeromq");
      reader.setDaemon(true);
      reader.start();
    }
  }

  private void read(Sink sink) {
    try {
      while (true) {
        sink.arrived(Contents.sentNanos(ByteBuffer.wrap(socket.recv())));
      }
    } catch (ZMQException e) {
      if (e.getErrorCode() != ZMQ.Error.ETERM.getCode()) {
        throw e;
      }
      socket.close(); // closed meanwhile
    }
  }

  @Override
  public void send(long sentNanos) {
    socket.send(Contents.bytes(load.bytes(), sentNanos));
  }

  @Override
  public void close() {
    context.close();
  }
}
