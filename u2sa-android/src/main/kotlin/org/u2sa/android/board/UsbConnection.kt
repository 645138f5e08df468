package org.u2sa.android.board

import android.hardware.usb.UsbAccessory
import android.hardware.usb.UsbManager
import android.os.ParcelFileDescriptor
import ioio.lib.impl.FixedReadBufferedInputStream
import java.io.FileInputStream
import java.io.FileOutputStream
import java.io.IOException

private const val READ_BYTES = 1_024 // some phones deliver accessory data only in whole buffers
private const val OPEN = 0
private const val OPENED = 1

/**
 * USB connection with the board as host (Android Open Accessory). The board cannot detect a vanished peer, so both sides
 * exchange a byte before talking.
 */
internal class UsbConnection(private val usb: UsbManager, link: BoardLink) : PhoneConnection(link) {
    @Volatile private var descriptor: ParcelFileDescriptor? = null

    override fun connect(): Streams {
        val accessory = usb.accessoryList?.firstOrNull(::isBoard) ?: throw IOException("no IOIO at the USB port")
        if (!usb.hasPermission(accessory)) {
            throw IOException("permission to use the IOIO at the USB port was denied: unplug it and plug it in again")
        }
        val made = usb.openAccessory(accessory) ?: throw IOException("the IOIO at the USB port cannot be opened")
        descriptor = made
        try {
            return handShaken(made)
        } catch (e: IOException) {
            made.close()
            throw e
        }
    }

    private fun isBoard(accessory: UsbAccessory) =
        accessory.manufacturer == MANUFACTURER && accessory.model == MODEL

    private fun handShaken(made: ParcelFileDescriptor): Streams {
        val input = FixedReadBufferedInputStream(FileInputStream(made.fileDescriptor), READ_BYTES)
        val output = FileOutputStream(made.fileDescriptor)
        output.write(OPEN)
        while (true) {
            when (input.read()) { // skip bytes left from an earlier connection
                OPENED -> return Streams(input, output, made)
                -1 -> throw IOException("the IOIO at the USB port was unplugged")
            }
        }
    }

    override fun abort() {
        descriptor?.close()
    }

    /** The library then ends the session with a message, because an accessory cannot be closed from this side alone. */
    override fun canClose() = false

    companion object {
        /** Name used by the firmware (app_layer_v1/main.c) and in res/xml/accessory_filter.xml. */
        const val MANUFACTURER = "IOIO Open Source Project"
        const val MODEL = "IOIO"
    }
}
