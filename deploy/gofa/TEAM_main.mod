MODULE TEAM_main
    ! The program of a cell in which TEAM alone moves the arm.
    ! A cell with a main of its own leaves this module out and calls TEAM_guide where TEAM is to
    ! take over: two routines called main are an error (40160).

    PROC main()
        TEAM_guide;
    ENDPROC
ENDMODULE
