package org.u2sa.android.board

import java.io.IOException
import java.net.InetSocketAddress
import java.net.Socket

private const val CONNECT_MS = 3_000

/** Connects to a board on a TCP port: a simulated one, or a serial port on the network. */
internal class TcpConnection(private val host: String, private val port: Int, link: BoardLink) : PhoneConnection(link) {
    @Volatile private var socket: Socket? = null

    override fun connect(): Streams {
        val made = Socket()
        socket = made // for abort
        try {
            made.connect(InetSocketAddress(host, port), CONNECT_MS)
            made.tcpNoDelay = true
            return Streams(made.inputStream, made.outputStream, made)
        } catch (e: IOException) {
            made.close()
            throw IOException("no answer at $host:$port: ${e.message}", e)
        }
    }

    override fun abort() {
        socket?.close()
    }

    override fun canClose() = true
}
