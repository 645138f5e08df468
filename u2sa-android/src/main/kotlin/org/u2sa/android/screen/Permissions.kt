package org.u2sa.android.screen

import org.u2sa.android.text.Text
import android.Manifest
import android.content.Context
import android.content.pm.PackageManager
import android.os.Build
import org.u2sa.android.board.BoardChoice

/** Runtime permissions to request on this Android version, with reasons. */
internal class Permissions(private val context: Context) {
    /** @property permissions permissions requested together */
    enum class Need(val permissions: List<String>, val why: Text, val short: Text) {
        LOCATION(
            // Since Android 12 the user may choose coarse location; both must be requested.
            listOf(Manifest.permission.ACCESS_FINE_LOCATION, Manifest.permission.ACCESS_COARSE_LOCATION),
            Text.PERMISSION_LOCATION,
            Text.PERMISSION_LOCATION_SHORT,
        ),
        BLUETOOTH(
            listOf("android.permission.BLUETOOTH_CONNECT"),
            Text.PERMISSION_BLUETOOTH,
            Text.PERMISSION_BLUETOOTH_SHORT,
        ),
        CAMERA(listOf(Manifest.permission.CAMERA), Text.PERMISSION_CAMERA, Text.PERMISSION_CAMERA_SHORT),
        NOTIFICATIONS(
            listOf("android.permission.POST_NOTIFICATIONS"),
            Text.PERMISSION_NOTIFICATIONS,
            Text.PERMISSION_NOTIFICATIONS_SHORT,
        ),
    }

    /**
     * Useful permissions not granted yet.
     *
     * @param board connection to the board
     * @param camera whether a service uses the camera
     */
    fun missing(board: BoardChoice, camera: Boolean): List<Need> = buildList {
        add(Need.LOCATION)
        if (camera) {
            add(Need.CAMERA)
        }
        if (board is BoardChoice.Bluetooth && Build.VERSION.SDK_INT >= Build.VERSION_CODES.S) {
            add(Need.BLUETOOTH)
        }
        if (Build.VERSION.SDK_INT >= Build.VERSION_CODES.TIRAMISU) {
            add(Need.NOTIFICATIONS)
        }
    }.filterNot(::isGiven)

    /** Whether paired adapters may be listed and used. */
    fun mayUseBluetooth(): Boolean = Build.VERSION.SDK_INT < Build.VERSION_CODES.S || isGiven(Need.BLUETOOTH)

    private fun isGiven(need: Need) =
        context.checkSelfPermission(need.permissions.first()) == PackageManager.PERMISSION_GRANTED
}
