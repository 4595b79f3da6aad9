// later is value, CLOCKS clocks ago.
`default_nettype none

module delay #(
    parameter WIDTH = 1,
    parameter CLOCKS = 1
) (
    input  wire             clock,
    input  wire [WIDTH-1:0] value,
    output wire [WIDTH-1:0] later
);
    reg [WIDTH-1:0] line [0:CLOCKS-1];
    integer         i;

    always @(posedge clock) begin
        line[0] <= value;
        for (i = 1; i < CLOCKS; i = i + 1) line[i] <= line[i-1];
    end
    assign later = line[CLOCKS-1];
endmodule
