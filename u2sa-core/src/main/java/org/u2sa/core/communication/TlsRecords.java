package org.u2sa.core.communication;

import io.netty.buffer.ByteBuf;
import io.netty.channel.ChannelHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.ChannelInboundHandlerAdapter;
import io.netty.handler.codec.ByteToMessageDecoder;
import io.netty.handler.ssl.SslHandshakeCompletionEvent;
import java.util.List;
import org.u2sa.core.communication.limit.Allowance;

/**
 * Passes single TLS records to the decryption and limits those without data, which are
 * disproportionately expensive: a TLS 1.3 KeyUpdate (RFC 8446, section 4.6.3) has 27 bytes and
 * derives new keys on the network thread. Rejects renegotiation, which TLS 1.2 allows. Confined to
 * its connection's thread.
 */
final class TlsRecords extends ByteToMessageDecoder {
  /** Burst of records without data; a handshake needs about five. */
  static final int WITHOUT_DATA_AT_ONCE = 12;

  private static final double WITHOUT_DATA_PER_S = 8.0 / 60.0; // clients rarely renew their keys

  private static final int HEADER = 5; // type, version, length; RFC 8446, section 5.1
  private static final int LENGTH_AT = 3;
  private static final int MIN_TYPE = 20;
  private static final int HANDSHAKE = 22;
  private static final int MAX_TYPE = 24;
  private static final int MAX_LENGTH = (16 << 10) + 2_048; // TLS 1.2; less in TLS 1.3

  private final Client session;
  private final BrokerState broker;
  private final Allowance withoutData;
  private boolean established;
  private boolean hadData = true; // the last record; true before the first
  private boolean ended;

  TlsRecords(BrokerState broker, Client session) {
    this.broker = broker;
    this.session = session;
    withoutData = new Allowance(WITHOUT_DATA_PER_S, WITHOUT_DATA_AT_ONCE, broker.nowMicros());
  }

  /** Handler placed after the decryption; detects records with data. */
  ChannelHandler behind() {
    return new Behind();
  }

  @Override
  protected void decode(ChannelHandlerContext ctx, ByteBuf in, List<Object> out) {
    if (!ended && !hadData && !mayCarryNoData()) {
      end("connection closed, too many TLS records without data");
    }
    hadData = true; // counted
    if (ended || session.isOut()) {
      in.skipBytes(in.readableBytes());
      return;
    }
    if (in.readableBytes() < HEADER) {
      return;
    }
    int type = in.getUnsignedByte(in.readerIndex());
    int length = in.getUnsignedShort(in.readerIndex() + LENGTH_AT);
    if (type < MIN_TYPE || type > MAX_TYPE || length > MAX_LENGTH) {
      out.add(in.readRetainedSlice(in.readableBytes())); // the decryption reports the error
    } else if (established && type == HANDSHAKE) {
      end("connection closed, it started a second TLS handshake");
      in.skipBytes(in.readableBytes());
    } else if (in.readableBytes() >= HEADER + length) {
      out.add(in.readRetainedSlice(HEADER + length));
      hadData = false; // until data is seen
    }
  }

  private boolean mayCarryNoData() {
    boolean may = withoutData.isOpen(broker.nowMicros());
    withoutData.take(1.0);
    return may;
  }

  private void end(String kind) {
    ended = true;
    session.putOutFor(kind);
  }

  private final class Behind extends ChannelInboundHandlerAdapter {
    @Override
    public void channelRead(ChannelHandlerContext ctx, Object message) {
      hadData = true;
      ctx.fireChannelRead(message);
    }

    @Override
    public void userEventTriggered(ChannelHandlerContext ctx, Object event) {
      if (event instanceof SslHandshakeCompletionEvent completion && completion.isSuccess()) {
        established = true;
      }
      ctx.fireUserEventTriggered(event);
    }
  }
}
