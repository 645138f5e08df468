package org.u2sa.android.board

import org.u2sa.interfaces.BadInputException

/** Connection from the phone to the IOIO board. */
sealed class BoardChoice {
    /** As in the system's configuration file, for example tcp:192.168.0.2:4545 for a simulator. */
    object Configured : BoardChoice() {
        override fun toString() = "configured"
    }

    /** USB cable with the IOIO as host and the phone as accessory. */
    object Usb : BoardChoice() {
        override fun toString() = "usb"
    }

    /** A Bluetooth adapter paired in Android's settings. */
    data class Bluetooth(val device: String) : BoardChoice() {
        override fun toString() = "bluetooth:$device"
    }

    /** A real or simulated board on a TCP port. */
    data class Tcp(val host: String, val port: Int) : BoardChoice() {
        override fun toString() = "tcp:$host:$port"
    }

    companion object {
        private val MAC = Regex("([0-9A-F]{2}:){5}[0-9A-F]{2}")
        private val TCP = Regex("tcp:([^\\s:]+):(\\d{1,5})")
        private const val BLUETOOTH = "bluetooth:"
        private const val HIGHEST_PORT = 65_535

        /**
         * Parses the output of [toString].
         *
         * @throws BadInputException quoting the text and the expected form
         */
        fun parse(text: String): BoardChoice {
            val tcp = TCP.matchEntire(text)
            return when {
                text == Configured.toString() -> Configured
                text == Usb.toString() -> Usb
                text.startsWith(BLUETOOTH) && MAC.matches(text.removePrefix(BLUETOOTH)) ->
                    Bluetooth(text.removePrefix(BLUETOOTH))
                tcp != null && tcp.groupValues[2].toInt() in 1..HIGHEST_PORT ->
                    Tcp(tcp.groupValues[1], tcp.groupValues[2].toInt())
                else -> throw BadInputException(
                    "board \"$text\": expected \"configured\", \"usb\", \"bluetooth:00:11:22:33:44:55\" or \"tcp:host:port\"",
                )
            }
        }
    }
}
