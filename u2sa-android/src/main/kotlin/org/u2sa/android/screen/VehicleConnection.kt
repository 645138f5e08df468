package org.u2sa.android.screen

import android.app.Activity
import android.content.ComponentName
import android.content.Context
import android.content.Intent
import android.content.ServiceConnection
import android.os.IBinder
import org.u2sa.android.vehicle.VehicleService

/** A screen's hold on the service that carries the vehicle: from when it is seen until it is not. */
internal class VehicleConnection(private val activity: Activity) : ServiceConnection {
    /** Null while the screen is not connected. */
    var service: VehicleService? = null
        private set

    fun open() {
        activity.bindService(Intent(activity, VehicleService::class.java), this, Context.BIND_AUTO_CREATE)
    }

    fun close() {
        activity.unbindService(this)
        service = null
    }

    /** Asks Android to let the service go on when this screen is gone, and to start the vehicle. */
    fun startVehicle() {
        activity.startForegroundService(Intent(activity, VehicleService::class.java).setAction(VehicleService.START))
    }

    override fun onServiceConnected(name: ComponentName, binder: IBinder) {
        service = (binder as VehicleService.Access).service
    }

    override fun onServiceDisconnected(name: ComponentName) {
        service = null
    }
}
