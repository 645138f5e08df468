package org.u2sa.android.board

import ioio.lib.api.IOIOConnection
import ioio.lib.api.exception.ConnectionLostException
import java.io.Closeable
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream

/**
 * One connection attempt to the board and the resulting connection; each attempt uses a new instance. Subclasses implement
 * Bluetooth and USB.
 */
internal abstract class PhoneConnection(private val link: BoardLink) : IOIOConnection {
    /** Input and output streams, and an action that closes both. */
    protected class Streams(val input: InputStream, val output: OutputStream, val end: Closeable)

    private val lock = Any()
    private var streams: Streams? = null
    private var ended = false

    /**
     * Connects; may block for seconds.
     *
     * @throws IOException if connecting fails
     */
    @Throws(IOException::class)
    protected abstract fun connect(): Streams

    /** Aborts a [connect] on another thread, if supported. */
    @Throws(IOException::class)
    protected abstract fun abort()

    @Throws(ConnectionLostException::class)
    override fun waitForConnect() {
        val made = try {
            connect()
        } catch (e: IOException) {
            throw lost(e)
        } catch (e: SecurityException) { // permission revoked
            throw lost(e)
        }
        synchronized(lock) {
            if (!ended) {
                streams = made
                link.established(this)
                return
            }
        }
        made.end.close()
        throw ConnectionLostException()
    }

    private fun lost(e: Exception): ConnectionLostException {
        link.lost(this, e.message ?: e.toString())
        return ConnectionLostException(e)
    }

    override fun disconnect() {
        val open = synchronized(lock) {
            if (ended) {
                return
            }
            ended = true
            streams
        }
        link.lost(this, "")
        try {
            abort()
            open?.end?.close()
        } catch (e: IOException) {
            link.lost(this, "does not close: ${e.message}") // the connection is no longer used
        }
    }

    @Throws(ConnectionLostException::class)
    override fun getInputStream(): InputStream = Watched(standing().input)

    @Throws(ConnectionLostException::class)
    override fun getOutputStream(): OutputStream = standing().output

    private fun standing(): Streams = synchronized(lock) { streams } ?: throw ConnectionLostException()

    /** Bytes from the board; a broken connection shows up here first. */
    private inner class Watched(private val source: InputStream) : InputStream() {
        override fun read(): Int = noting { source.read() }

        override fun read(buffer: ByteArray, offset: Int, length: Int): Int = noting { source.read(buffer, offset, length) }

        override fun available(): Int = source.available()

        override fun close() = source.close()

        private fun noting(read: () -> Int): Int {
            try {
                val got = read()
                if (got < 0) {
                    link.lost(this@PhoneConnection, "the board ended the connection")
                }
                return got
            } catch (e: IOException) {
                link.lost(this@PhoneConnection, "the connection broke: ${e.message}")
                throw e
            }
        }
    }
}
