package org.u2sa.android.board

import ioio.lib.api.IOIOConnection
import ioio.lib.api.exception.ConnectionLostException
import java.io.Closeable
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream

/**
 * One attempt to reach the board by what the phone has, and the connection that comes of it; for the next attempt another one is
 * made. Whether what carries it is a Bluetooth socket or a USB cable is the subclass's concern.
 */
internal abstract class PhoneConnection(private val link: BoardLink) : IOIOConnection {
    /** Two directions, and what ends both. */
    protected class Streams(val input: InputStream, val output: OutputStream, val end: Closeable)

    private val lock = Any()
    private var streams: Streams? = null
    private var ended = false

    /**
     * Makes the connection; may take seconds.
     *
     * @throws IOException if that fails
     */
    @Throws(IOException::class)
    protected abstract fun connect(): Streams

    /** Makes a [connect] on another thread fail soon, if that can be done. */
    @Throws(IOException::class)
    protected abstract fun abort()

    @Throws(ConnectionLostException::class)
    override fun waitForConnect() {
        val made = try {
            connect()
        } catch (e: IOException) {
            throw lost(e)
        } catch (e: SecurityException) { // the permission was taken away
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
            link.lost(this, "does not close: ${e.message}") // nothing of it is used any more
        }
    }

    @Throws(ConnectionLostException::class)
    override fun getInputStream(): InputStream = Watched(standing().input)

    @Throws(ConnectionLostException::class)
    override fun getOutputStream(): OutputStream = standing().output

    private fun standing(): Streams = synchronized(lock) { streams } ?: throw ConnectionLostException()

    /** The bytes from the board: that a connection broke shows in reading first. */
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
