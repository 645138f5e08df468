package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.util.ReferenceCountUtil;
import org.u2sa.core.communication.limit.BrokerLimits;

/**
 * Passes complete MQTT packets to the decoder, so that it reads each byte once, however the packets
 * were fragmented. Rejects packets that are too long for their type as soon as their length is
 * known (MQTT 3.1.1, section 2.2), and packets whose contents exceed their length, for which the
 * decoder would wait and start over with each further byte. Confined to its connection's thread.
 */
final class PacketFramer extends ChannelInboundHandlerAdapter {
  private static final int CONNECT = 1;
  private static final int PUBLISH = 3;
  private static final int TYPE_BITS = 4; // next to the flags
  private static final int MAX_LENGTH_BYTES = 4;
  private static final int LENGTH_BITS = 7; // of each byte of a packet's length
  private static final int INCOMPLETE = -1; // length not known yet
  private static final int REFUSED = -2;

  private final Client session;
  private final Inflow inflow;
  private final MemoryBudget<Client> unfinished;
  private ByteBuf pending; // start of an incomplete packet; null if none
  private int pendingLength; // of that packet with its header; INCOMPLETE until known
  private long handedOn; // number of packets passed on
  private boolean isClosed;

  /**
   * @param inflow counts the decoded packets
   * @param unfinished budget for incomplete packets of all connections
   */
  PacketFramer(Client session, Inflow inflow, MemoryBudget<Client> unfinished) {
    this.session = session;
    this.inflow = inflow;
    this.unfinished = unfinished;
  }

  @Override
  public void channelRead(ChannelHandlerContext ctx, Object message) {
    ByteBuf received = (ByteBuf) message;
    if (isClosed) {
      received.release();
    } else if (pending == null) {
      split(ctx, received);
    } else {
      ByteBuf data = pending.writeBytes(received);
      received.release();
      if (pendingLength == INCOMPLETE || data.readableBytes() >= pendingLength) {
        pending = null;
        split(ctx, data);
      }
      unfinished.set(session, pending == null ? 0 : pending.readableBytes());
    }
  }

  /** Passes on complete packets and keeps the rest. Takes ownership of the data. */
  private void split(ChannelHandlerContext ctx, ByteBuf data) {
    int packets = 0;
    int end = data.readerIndex();
    int length = length(data, end);
    while (length >= 0 && length <= data.writerIndex() - end) {
      packets++;
      end += length;
      length = length(data, end);
    }
    if (packets > 0) {
      handOn(ctx, data.readRetainedSlice(end - data.readerIndex()), packets);
    }
    if (length == REFUSED && !isClosed) {
      refuse();
    }
    if (data.isReadable() && !isClosed) {
      pending = ctx.alloc().buffer(data.readableBytes()).writeBytes(data);
      pendingLength = length;
      unfinished.set(session, pending.readableBytes());
    }
    data.release();
  }

  private void handOn(ChannelHandlerContext ctx, ByteBuf complete, int packets) {
    handedOn += packets;
    ctx.fireChannelRead(complete);
    if (inflow.decoded() != handedOn && !isClosed) {
      refuse(); // contents exceed the packet
    }
  }

  private void refuse() {
    isClosed = true;
    session.putOutFor(ConnectionFault.MALFORMED);
  }

  /** Length of the packet at an index including its header, or INCOMPLETE or REFUSED. */
  private static int length(ByteBuf data, int start) {
    int remaining = 0;
    for (int i = 1; i <= MAX_LENGTH_BYTES; i++) {
      if (start + i >= data.writerIndex()) {
        return INCOMPLETE;
      }
      int digit = data.getByte(start + i);
      remaining |= (digit & 0x7f) << LENGTH_BITS * (i - 1);
      if (digit >= 0) {
        int length = 1 + i + remaining;
        return length > maxLength(data.getByte(start)) ? REFUSED : length;
      }
    }
    return REFUSED;
  }

  private static int maxLength(byte first) {
    return switch ((first & 0xff) >> TYPE_BITS) {
      case CONNECT -> BrokerLimits.LONGEST_CONNECT;
      case PUBLISH -> BrokerLimits.LONGEST_PACKET;
      default -> BrokerLimits.LONGEST_CONTROL_PACKET;
    };
  }

  @Override
  public void handlerRemoved(ChannelHandlerContext ctx) {
    isClosed = true;
    ReferenceCountUtil.release(pending);
    pending = null;
    unfinished.set(session, 0);
  }
}
