// The stage cell: place in the cell and addresses of its corners, SPEC.md, sections 3 and 10.
`default_nettype none
`include "layout.vh"

module bench_cell (
    output reg done
);
    localparam STAGE = "cell";
    localparam ROWS = `cell_ROWS;
    localparam BITS = `cell_BITS;
`include "bench.vh"

    wire [23:0]     f;
    wire [8*46-1:0] address;

    addresses unit (clock, {row[`cell_n2_top-3 -: 13], row[`cell_n1_top-3 -: 13],
        row[`cell_n0_top-3 -: 13]}, {row[`cell_stride2], row[`cell_stride1], row[`cell_stride0]},
        {row[`cell_place2], row[`cell_place1], row[`cell_place0]},
        {row[`cell_advance2], row[`cell_advance1], row[`cell_advance0]},
        row[`cell_k_top-1 -: 23], f, address);

    // The column has 32 bits, the unit 46: their upper bits are all the sign.
    wire [8*32-1:0] address32;
    wire [7:0]      fits;
    genvar          q;

    generate
        for (q = 0; q < 8; q = q + 1) begin : corner
            assign address32[32*q +: 32] = address[46*q +: 32];
            assign fits[q] = &address[46*q+31 +: 15] || ~|address[46*q+31 +: 15];
        end
    endgenerate

    always @(negedge clock) if (!done) begin
        edges = edges + 1;
        `EXPECT(2, "point", 0, `cell_point0, unit.axis[0].one.point);
        `EXPECT(2, "point", 1, `cell_point1, unit.axis[1].one.point);
        `EXPECT(2, "point", 2, `cell_point2, unit.axis[2].one.point);
        for (i = 0; i < 3; i = i + 1) `EXPECT(4, "f", i, `cell_f0_top - 8 * i -: 8, f[8*i +: 8]);
        for (i = 0; i < 8; i = i + 1)
            `EXPECT(6, "address", i, `cell_address0_top - 32 * i -: 32,
                fits[i] ? {32'd0, address32[32*i +: 32]} : {18'd0, address[46*i +: 46]});
        finish_after(6);
    end
endmodule
