package org.u2sa.android.board

import android.bluetooth.BluetoothAdapter
import android.bluetooth.BluetoothSocket
import ioio.lib.impl.FixedReadBufferedInputStream
import java.io.IOException
import java.util.UUID

private val SERIAL_PORT_PROFILE = UUID.fromString("00001101-0000-1000-8000-00805F9B34FB") // Bluetooth assigned numbers, 0x1101
private const val READ_BYTES = 64

/**
 * Connects to the board through a paired Bluetooth adapter (Serial Port Profile).
 *
 * @param adapter null if the phone has no Bluetooth
 * @param device its hardware address
 */
internal class BluetoothConnection(
    private val adapter: BluetoothAdapter?,
    private val device: String,
    link: BoardLink,
) : PhoneConnection(link) {
    @Volatile private var socket: BluetoothSocket? = null

    override fun connect(): Streams {
        val present = adapter ?: throw IOException("the phone has no Bluetooth")
        if (!present.isEnabled) {
            throw IOException("Bluetooth is switched off")
        }
        // insecure socket: the cheap dongles that fit the board support only a PIN
        val made = present.getRemoteDevice(device).createInsecureRfcommSocketToServiceRecord(SERIAL_PORT_PROFILE)
        socket = made // for abort
        try {
            made.connect()
            return Streams(FixedReadBufferedInputStream(made.inputStream, READ_BYTES), made.outputStream, made)
        } catch (e: IOException) {
            made.close()
            throw IOException("no connection to $device: ${e.message}", e)
        }
    }

    override fun abort() {
        socket?.close()
    }

    override fun canClose() = true
}
